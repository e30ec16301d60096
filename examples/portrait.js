/** Shared code of the examples: a lit face with controls below it. Not part of the library. */

import * as three from 'three'

const { Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene } = three

/**
 * Shows a face and draws every frame.
 *
 * @param {import('three').Object3D} face
 * @param {(seconds: number) => void} [beforeFrame] called with the seconds since the page was opened.
 * @param {import('three').WebGLRenderer | import('three/webgpu').WebGPURenderer} [renderer] required where the import map's `three` is
 *   the build without `WebGLRenderer`.
 */
export function showFace(
  face,
  beforeFrame = () => {},
  renderer = new three.WebGLRenderer({ antialias: true }),
) {
  const key = new DirectionalLight('#fff1e4', 3)
  key.position.set(-0.9, 0.9, 0.8)
  const scene = new Scene()
  scene.background = new Color('#d9d6d1')
  scene.add(face, key, new HemisphereLight('#dfe8ff', '#6b5a50', 0.8))
  const camera = new PerspectiveCamera(22, 1, 0.1, 10)
  camera.position.set(0, 0.765, 0.93)
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
  document.body.prepend(renderer.domElement)
  const resize = () => {
    const { clientWidth: width } = document.body
    const height = Math.max(240, innerHeight - controls().offsetHeight)
    camera.aspect = width / height
    // Fits the whole face into a narrow page ...
    camera.fov = Math.min(48, 22 / Math.min(1, camera.aspect / 0.8))
    // ... and keeps the lower edge of the shirt out of the frame.
    camera.position.y = 0.765 + 0.11 * (camera.fov / 22 - 1)
    camera.updateProjectionMatrix()
    renderer.setSize(width, height)
  }
  addEventListener('resize', resize)
  resize()
  renderer.setAnimationLoop((milliseconds) => {
    beforeFrame(milliseconds / 1000)
    renderer.render(scene, camera)
  })
  return { camera, renderer }
}

/**
 * Calls a function while the pointer is dragged over a mesh.
 *
 * @param {ReturnType<typeof showFace>} view
 * @param {(hit: { uv: import('three').Vector2, isFirst: boolean }) => void} onHit `isFirst`: the drag has just begun.
 */
export function onDrag({ camera, renderer: { domElement: canvas } }, mesh, onHit) {
  const raycaster = new three.Raycaster()
  const pointer = new three.Vector2()
  const hitAt = ({ offsetX, offsetY }, isFirst) => {
    pointer.set((2 * offsetX) / canvas.clientWidth - 1, 1 - (2 * offsetY) / canvas.clientHeight)
    raycaster.setFromCamera(pointer, camera)
    const [hit] = raycaster.intersectObject(mesh, false)
    if (hit) onHit({ uv: hit.uv, isFirst })
  }
  canvas.style.touchAction = 'none'
  canvas.style.cursor = 'crosshair'
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId)
    hitAt(event, true)
  })
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons > 0) hitAt(event, false)
  })
}

/** Sets a blendshape of every mesh of a face that has it, 0..1. */
export function setTarget(face, name, weight) {
  face.traverse(({ morphTargetDictionary: targets, morphTargetInfluences: weights }) => {
    if (targets && name in targets) weights[targets[name]] = weight
  })
}

/** Adds a labelled slider that calls `onChange`. Returns a function that sets it without calling `onChange`. */
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

/** Adds a button for each name. */
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

/** Adds a checkbox. */
export function addCheck(name, checked, onChange) {
  const label = document.createElement('label')
  const input = Object.assign(document.createElement('input'), { type: 'checkbox', checked })
  input.addEventListener('change', () => onChange(input.checked))
  label.append(input, name)
  controls().append(label)
}

/** Adds lines of text. Returns a function that replaces them. */
export function addText() {
  const text = document.createElement('pre')
  controls().append(text)
  return (content) => {
    if (text.textContent !== content) text.textContent = content
  }
}

/** Adds a bar that shows a fraction, 0..1, and can be removed. */
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

function controls() {
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
    form pre { flex-basis: 100%; min-width: 0; margin: 0; min-height: 9em; font-size: 12px; white-space: pre-wrap; overflow-wrap: anywhere }
    form output { width: 2.6em; font-variant-numeric: tabular-nums }
    form div { display: flex; flex-wrap: wrap; gap: 6px; flex-basis: 100% }
    form div label { margin-right: 8px }
    form button { font: inherit; padding: 7px 12px; border: 0; border-radius: 6px; background: #4b5563; color: inherit; cursor: pointer }
    form button:hover, form button:focus-visible { background: #6b7688 }`
  document.head.append(style)
  return form
}
