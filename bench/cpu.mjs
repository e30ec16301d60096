// What one face costs the processor per frame: 57 blendshapes drive 64 areas, all of which move. Uses the build of the
// packages, as pages do, and a renderer that draws nothing.

import { setFlagsFromString } from 'node:v8'
import { runInNewContext } from 'node:vm'
import { driveByMorphs, Wrinkles } from 'furrow/three'
import { BufferAttribute, Mesh, MeshStandardMaterial, PerspectiveCamera, PlaneGeometry, Scene } from 'three'

setFlagsFromString('--expose-gc')
const collect = runInNewContext('gc')

const TARGETS = 57
const AREAS = 64
/** Targets that move an area: as many as a driver of the shipped face has. */
const LINKS = 4
const ROUNDS = 15
const FRAMES = 20_000

/** Medians over rounds: microseconds and bytes for each frame. */
export function measureCpu(median) {
  const frame = movingFace()
  for (let i = 0; i < 3 * FRAMES; i++) frame(i)
  const rounds = Array.from({ length: ROUNDS }, (_, round) => {
    collect()
    const used = process.memoryUsage().heapUsed
    const start = performance.now()
    for (let i = 0; i < FRAMES; i++) frame(round * FRAMES + i)
    const milliseconds = performance.now() - start
    return {
      microseconds: (1000 * milliseconds) / FRAMES,
      bytes: (process.memoryUsage().heapUsed - used) / FRAMES,
    }
  })
  return {
    targets: TARGETS,
    areas: AREAS,
    microseconds: median(rounds.map(({ microseconds }) => microseconds)),
    bytes: median(rounds.map(({ bytes }) => bytes)),
  }
}

/** Draws one frame with all blendshapes elsewhere. */
function movingFace() {
  const geometry = new PlaneGeometry()
  geometry.morphAttributes.position = Array.from({ length: TARGETS }, (_, i) => {
    const attribute = new BufferAttribute(new Float32Array(12), 3)
    attribute.name = `target${i}`
    return attribute
  })
  const mesh = new Mesh(geometry, new MeshStandardMaterial())
  const side = 16
  const weights = { width: side, height: side, data: new Uint8Array(side * side).fill(255) }
  const normal = { width: 1, height: 1, data: Uint8Array.of(128, 128, 255, 255) }
  const areas = Array.from({ length: AREAS }, (_, i) => ({ name: `area${i}`, weights }))
  const wrinkles = new Wrinkles(mesh, { layers: [{ name: 'all', kind: 'detail', normal }], areas })
  driveByMorphs(
    wrinkles,
    areas.map(({ name }, i) => driver(name, i)),
  )
  const renderer = idleRenderer()
  const scene = new Scene()
  const camera = new PerspectiveCamera()
  const influences = mesh.morphTargetInfluences
  return (at) => {
    for (let i = 0; i < TARGETS; i++) influences[i] = ((at * 7 + i * 13) % 100) / 100
    renderer.info.calls++
    mesh.onBeforeRender(renderer, scene, camera, geometry, mesh.material, null)
  }
}

function driver(area, i) {
  const targets = Array.from({ length: LINKS }, (_, k) => ({
    name: `target${(i * 5 + k * 11) % TARGETS}`,
    weight: 0.4,
  }))
  const curve = [
    [0.1, 0],
    [0.6, 0.7],
    [1, 1],
  ]
  return { type: 'morph', area, targets, curve }
}

/** As much of a renderer as is called; what it does with the draw is three.js's part and the same for any draw. */
function idleRenderer() {
  const held = { __webglTexture: true }
  return {
    info: { calls: 0, autoReset: true },
    autoClear: true,
    xr: { enabled: false },
    shadowMap: { autoUpdate: true },
    properties: { get: () => held },
    getRenderTarget: () => null,
    getActiveCubeFace: () => 0,
    getActiveMipmapLevel: () => 0,
    setRenderTarget() {},
    render() {
      this.info.calls++
    },
  }
}
