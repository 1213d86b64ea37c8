// The page works without this: it adds the copy button and closes an enlarged picture on Escape.
(() => {
  const button = document.getElementById('copy');
  const command = document.getElementById('command');
  const select = () => {
    const range = document.createRange();
    range.selectNodeContents(command);
    const selection = getSelection();
    selection.removeAllRanges();
    selection.addRange(range);
  };
  const say = (text) => {
    button.textContent = text;
    setTimeout(() => { button.textContent = 'Copy'; }, 2000);
  };
  button.hidden = false;
  button.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(command.textContent);
      say('Copied');
    } catch {
      select();  // pages opened from disk may not reach the clipboard
      say(document.execCommand('copy') ? 'Copied' : 'Selected');
    }
  });
  addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && location.hash.startsWith('#picture-')) location.hash = '#pictures';
  });
})();
