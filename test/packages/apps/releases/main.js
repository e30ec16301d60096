// Draws the shipped face with `WebGLRenderer` on one release of three.js. `?step=influence` runs only one of the steps below.

import {
  frameFace,
  setDrivers,
  updateArea,
  updateLayer,
  WrinkleLoaderPlugin,
  Wrinkles,
  wrinklesOf,
} from 'furrow/three'
import {
  AmbientLight,
  BatchedMesh,
  DirectionalLight,
  Mesh,
  MeshStandardMaterial,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  REVISION,
  Scene,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

const SIZE = 256
const MORPHS = ['browInnerUp', 'browOuterUpLeft', 'browOuterUpRight', 'mouthSmileLeft', 'mouthSmileRight']

const warnings = []
for (const name of ['warn', 'error']) {
  // biome-ignore lint/suspicious/noConsole: the test reads the messages
  const write = console[name]
  console[name] = (...words) => {
    warnings.push(words.join(' '))
    write.apply(console, words)
  }
}

const renderer = new WebGLRenderer({ antialias: true })
renderer.setSize(SIZE, SIZE)
document.body.append(renderer.domElement)

/** Creates a scene with the face and a camera in front of it. The face smiles with raised brows. */
async function openFace() {
  const loader = new GLTFLoader().register((parser) => new WrinkleLoaderPlugin(parser))
  const file = await loader.loadAsync('/wrinkled.glb')
  file.scene.traverse(({ morphTargetDictionary, morphTargetInfluences }) => {
    for (const name of MORPHS) {
      const index = morphTargetDictionary?.[name]
      if (index !== undefined) morphTargetInfluences[index] = 1
    }
  })
  const sun = new DirectionalLight('white', 3)
  sun.position.set(-0.6, 0.9, 1)
  const scene = new Scene().add(file.scene, sun, new AmbientLight('white', 0.4))
  const camera = new PerspectiveCamera(22, 1)
  frameFace(camera, file.scene)
  const [wrinkles] = wrinklesOf(file)
  // By default relief appears when its code is loaded, in a frame that varies between runs.
  wrinkles.relief = 'off'
  return { scene, camera, wrinkles }
}

/** Draws two frames and returns the second as RGB bytes. Wrinkles whose shader fails in the first frame are off in the second. */
async function picture(scene, camera) {
  const target = new WebGLRenderTarget(SIZE, SIZE)
  for (let frame = 0; frame < 2; frame++) {
    renderer.setRenderTarget(target)
    renderer.render(scene, camera)
    renderer.setRenderTarget(null)
    await new Promise((resolve) => setTimeout(resolve))
  }
  const pixels = new Uint8Array(SIZE * SIZE * 4)
  renderer.readRenderTargetPixels(target, 0, 0, SIZE, SIZE, pixels)
  target.dispose()
  return Array.from(pixels.filter((_, i) => i % 4 < 3))
}

/** Makes a material write its view-space normals instead of light. */
function showNormals(material) {
  const { onBeforeCompile, customProgramCacheKey } = material
  material.onBeforeCompile = (shader, ...rest) => {
    onBeforeCompile.call(material, shader, ...rest)
    const output = '#include <opaque_fragment>'
    if (!shader.fragmentShader.includes(output)) throw new Error(`the shader lacks ${output}`)
    shader.fragmentShader = shader.fragmentShader.replace(
      output,
      'gl_FragColor = vec4(normalize(normal) * 0.5 + 0.5, 1.0);',
    )
  }
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} normals`
  material.needsUpdate = true
}

/** Hides everything but the wrinkled mesh. */
function showAlone(scene, mesh) {
  scene.traverse((object) => {
    if (object.isMesh) object.visible = object === mesh
  })
}

const gray = (size, value) => ({ width: size, height: size, data: new Uint8Array(size * size).fill(value) })

/** Draws the skin with the influence as gray, before and after an area gets other weights. */
async function influence() {
  const { scene, camera, wrinkles } = await openFace()
  showAlone(scene, wrinkles.mesh)
  wrinkles.mesh.material = wrinkles.createInfluenceMaterial()
  const drawn = await picture(scene, camera)
  updateArea(wrinkles, 'foreheadLeft', gray(64, 128))
  return { drawn, painted: await picture(scene, camera) }
}

/** Draws the normals of the skin before and after a layer gets another normal map. */
async function normals() {
  const { scene, camera, wrinkles } = await openFace()
  showAlone(scene, wrinkles.mesh)
  showNormals(wrinkles.mesh.material)
  const drawn = await picture(scene, camera)
  const flat = { width: 1024, height: 1024, data: new Uint8Array(4 * 1024 * 1024) }
  for (let i = 0; i < flat.data.length; i += 4) flat.data.set([160, 128, 250, 255], i)
  updateLayer(wrinkles, 'expression', { normal: flat })
  const painted = await picture(scene, camera)
  return { drawn, painted }
}

/** Draws the lit face in each mode, and with relief. Light differs between releases of three.js. */
async function light() {
  const { scene, camera, wrinkles } = await openFace()
  const modes = {}
  for (const mode of ['off', 'paper', 'composed', 'default']) {
    wrinkles.mode = mode
    modes[mode] = await picture(scene, camera)
  }
  wrinkles.relief = 'on'
  await picture(scene, camera)
  await wrinkles.reliefReady()
  modes.relief = await picture(scene, camera)
  // Also draws on the canvas, for people and screenshots.
  renderer.render(scene, camera)
  return modes
}

/** Draws the normals of two instances of a `BatchedMesh`, the second with wrinkles. */
async function batch() {
  const plane = new PlaneGeometry(1, 1)
  const { wrinkles: source } = await openFace()
  const material = new MeshStandardMaterial()
  const mesh = new BatchedMesh(2, 8, 12, material)
  const ids = [0, 1].map(() => {
    const geometry = mesh.addGeometry(plane)
    return mesh.addInstance ? mesh.addInstance(geometry) : geometry
  })
  for (const [i, id] of ids.entries()) {
    const place = new Mesh()
    place.position.x = i - 0.5
    place.updateMatrix()
    mesh.setMatrixAt(id, place.matrix)
  }
  const wrinkles = new Wrinkles(mesh, source)
  // The instances are planes without the blendshapes that the drivers need.
  setDrivers(wrinkles, [])
  wrinkles.setActivation('foreheadLeft', 1, ids[1])
  showNormals(material)
  const camera = new OrthographicCamera(-1, 1, 1, -1, 0, 2)
  camera.position.z = 1
  return await picture(new Scene().add(mesh), camera)
}

const report = { release: REVISION }
const steps = { influence, normals, batch, light }
const wanted = new URLSearchParams(location.search).getAll('step')
for (const [name, step] of Object.entries(steps)) {
  if (wanted.length > 0 && !wanted.includes(name)) continue
  const before = warnings.length
  const result = await step().catch((error) => `${error}`)
  report[name] = { result, warnings: warnings.slice(before) }
}
window.report = report
document.title = 'done'
