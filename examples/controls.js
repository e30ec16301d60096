/** Controls below an example, for any engine. Not part of the library. */

/**
 * Adds a button for each expression. Plays the expression that the page's address names, such as `?expression=happy`,
 * or `initial` if the address names none.
 */
export function addExpressions(player, initial = 'surprised') {
  player.play(new URLSearchParams(location.search).get('expression') ?? initial, 0)
  addButtons(['neutral', 'surprised', 'happy', 'angry'], (name) => player.play(name, 0.4, 'easeInOut'))
}

/** Adds a labelled slider that calls `onChange`. Returns a function that sets the slider without calling `onChange`. */
export function addSlider(name, { min = 0, max = 1, step = 0.01, value = 0 }, onChange) {
  const label = document.createElement('label')
  const input = Object.assign(document.createElement('input'), { type: 'range', min, max, step, value })
  const output = document.createElement('output')
  const show = () => {
    output.textContent = step >= 1 ? input.value : Number(input.value).toFixed(2)
  }
  input.addEventListener('input', () => {
    show()
    onChange(Number(input.value))
  })
  label.append(name, input, output)
  controls().append(label)
  show()
  return (value) => {
    input.value = value
    show()
  }
}

export function addButtons(names, onPress) {
  const row = document.createElement('div')
  for (const name of names) {
    const button = Object.assign(document.createElement('button'), { textContent: name })
    button.addEventListener('click', () => onPress(name))
    row.append(button)
  }
  controls().append(row)
}

/** Adds radio buttons to choose one of several names. */
export function addChoice(names, chosen, onChoose) {
  const row = document.createElement('div')
  for (const name of names) {
    const label = document.createElement('label')
    const input = Object.assign(document.createElement('input'), {
      type: 'radio',
      name: 'choice',
      checked: name === chosen,
    })
    input.addEventListener('change', () => onChoose(name))
    label.append(input, name)
    row.append(label)
  }
  controls().append(row)
}

export function addCheck(name, checked, onChange) {
  const label = document.createElement('label')
  const input = Object.assign(document.createElement('input'), { type: 'checkbox', checked })
  input.addEventListener('change', () => onChange(input.checked))
  label.append(input, name)
  controls().append(label)
}

/** Adds a text field. Returns a function that reads the text. */
export function addField(name, value) {
  const label = document.createElement('label')
  const input = Object.assign(document.createElement('input'), { type: 'text', value })
  label.append(name, input)
  controls().append(label)
  return () => input.value
}

/** Adds an empty text block, which can hold several lines. Returns a function that sets the text. */
export function addText() {
  const text = document.createElement('pre')
  controls().append(text)
  return (content) => {
    if (text.textContent !== content) text.textContent = content
  }
}

/** Adds a progress bar. Returns two functions: `set` takes the progress, 0..1, and `remove` removes the bar. */
export function addProgress(name) {
  const label = document.createElement('label')
  const bar = Object.assign(document.createElement('progress'), { value: 0 })
  label.append(name, bar)
  controls().append(label)
  return {
    set(fraction) {
      bar.value = fraction
    },
    remove: () => label.remove(),
  }
}

/** Returns the form with the controls. Creates the form below the content of the page if it does not exist. */
export function controls() {
  const found = document.querySelector('form')
  if (found) return found
  const form = document.createElement('form')
  form.addEventListener('submit', (event) => event.preventDefault())
  document.body.append(form)
  const style = document.createElement('style')
  style.textContent = `
    body { margin: 0; font: 14px/1.4 system-ui, sans-serif; background: #23262b; color: #eee; overflow-x: hidden }
    canvas { display: block }
    form { display: flex; flex-wrap: wrap; gap: 6px 14px; padding: 10px; max-height: 32vh; overflow-y: auto; box-sizing: border-box }
    form label { display: flex; align-items: center; gap: 6px; min-height: 32px }
    form input[type=range] { width: 110px }
    form input[type=text] { width: 110px }
    form pre { flex-basis: 100%; min-width: 0; margin: 0; min-height: 9em; font-size: 12px; white-space: pre-wrap; overflow-wrap: anywhere }
    form output { width: 2.6em; font-variant-numeric: tabular-nums }
    form div { display: flex; flex-wrap: wrap; gap: 6px; flex-basis: 100% }
    form div label { margin-right: 8px }
    form button { font: inherit; padding: 7px 12px; border: 0; border-radius: 6px; background: #4b5563; color: inherit; cursor: pointer }
    form button:hover, form button:focus-visible { background: #6b7688 }`
  document.head.append(style)
  return form
}
