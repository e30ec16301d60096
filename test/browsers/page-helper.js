// Runs in every page before the page's own scripts: see page-helper.ts.

const complaints = []
for (const level of ['error', 'warn']) {
  // biome-ignore lint/suspicious/noConsole: forwards the page's messages.
  const write = console[level]
  console[level] = (...parts) => {
    complaints.push(parts.map(String).join(' '))
    write.apply(console, parts)
  }
}
addEventListener(
  'error',
  ({ message, target }) => complaints.push(message ?? `cannot load ${target.src}`),
  true,
)
addEventListener('unhandledrejection', ({ reason }) => complaints.push(String(reason?.stack ?? reason)))

/** Files saved by the page, newest last. */
const savedFiles = []
const createObjectURL = URL.createObjectURL
URL.createObjectURL = (blob) => {
  savedFiles.push(blob)
  return createObjectURL.call(URL, blob)
}

/**
 * Draws the page's scene with and without wrinkles at the same time, with the page's renderer.
 * @returns largest difference in a region given in fractions of the picture, and the contrast of the complete picture.
 */
async function compareWrinkles({ left, top, right, bottom }) {
  const imports = document.querySelector('script[type=importmap]').textContent
  const furrow = imports.includes('furrow/three') ? 'furrow/three' : 'furrow/webgpu'
  const [{ Scene }, { wrinklesOf }] = await Promise.all([import('three'), import(furrow)])
  const [renderer, scene, camera] = await new Promise((resolve) => {
    Scene.prototype.onBeforeRender = (...drawn) => resolve(drawn)
  })
  delete Scene.prototype.onBeforeRender
  // Lets the current frame end.
  await new Promise((resolve) => setTimeout(resolve))
  const all = new Set()
  scene.traverse((object) => object.isMesh && all.add(wrinklesOf(object)))
  all.delete(undefined)
  const [wrinkled, smooth] = ['default', 'off'].map((mode) => {
    for (const wrinkles of all) wrinkles.mode = mode
    renderer.render(scene, camera)
    return pixelsOf(renderer.domElement)
  })
  for (const wrinkles of all) wrinkles.mode = 'default'
  const { width, height, data } = wrinkled
  let difference = 0
  let [low, high] = [255, 0]
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = 4 * (y * width + x)
      low = Math.min(low, data[i])
      high = Math.max(high, data[i])
      const isInside = x >= left * width && x < right * width && y >= top * height && y < bottom * height
      if (isInside) difference = Math.max(difference, Math.abs(data[i] - smooth.data[i]))
    }
  }
  return { difference, contrast: high - low }
}

function pixelsOf(canvas) {
  const { width, height } = canvas
  const context = new OffscreenCanvas(width, height).getContext('2d')
  context.drawImage(canvas, 0, 0)
  return context.getImageData(0, 0, width, height)
}

/** Finds the first visible element that matches a selector and whose label or text is `name`, in the fieldset `group` if given. */
function findElement(selector, name, group) {
  const labelOf = (fieldset) => document.getElementById(fieldset.getAttribute('aria-labelledby'))?.textContent
  const fieldsets = [...document.querySelectorAll('fieldset')]
  const root = group === undefined ? document : fieldsets.find((fieldset) => labelOf(fieldset) === group)
  return [...(root?.querySelectorAll(selector) ?? [])].find((element) => {
    if (!element.checkVisibility()) return false
    const names = [element.getAttribute('aria-label'), element.textContent, element.labels?.[0]?.textContent]
    return name === undefined || names.some((text) => text?.trim() === name)
  })
}

/** Scrolls to an element. Returns its rectangle once it stays in the window, otherwise `null`. */
async function reachElement(...names) {
  const element = findElement(...names)
  if (!element) return null
  element.scrollIntoView({ block: 'center' })
  const before = element.getBoundingClientRect()
  // Rows that scroll into view may change height and move other rows.
  await new Promise((resolve) => setTimeout(resolve, 500))
  await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))
  const { x, y, width, height } = element.getBoundingClientRect()
  const isInside = y + height / 2 > 0 && y + height / 2 < innerHeight
  return isInside && x === before.x && y === before.y ? { x, y, width, height } : null
}

/** Returns the last saved file as base64. */
async function readSaved() {
  const bytes = new Uint8Array(await savedFiles.at(-1).arrayBuffer())
  let text = ''
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192))
  return btoa(text)
}

window.furrowTest = { complaints, savedFiles, compareWrinkles, findElement, reachElement, readSaved }
