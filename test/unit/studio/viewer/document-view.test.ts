import type { WrinkleSet } from 'furrow'
import { Wrinkles } from 'furrow/three'
import { beforeEach, expect, test, vi } from 'vitest'
import { meshOf } from '../../../../packages/furrow/src/three/wrinkles-base.ts'
import type { StudioDocument, StudioLayer } from '../../../../studio/src/document/document.ts'
import { DocumentView, type LayerMaps } from '../../../../studio/src/viewer/document-view.ts'
import type { Viewer } from '../../../../studio/src/viewer/viewer.ts'
import { blendMesh } from '../../../blend-mesh.ts'
import { randomNormals } from '../../../cases.ts'
import { seeded } from '../../../random.ts'
import { sampleDocument } from '../sample-document.ts'

const SIZE = 8

/** Returns a fake viewer, which counts how often wrinkles are created. */
function stubViewer() {
  const mesh = blendMesh()
  const viewer = {
    wrinkles: null as Wrinkles | null,
    setWrinkles: vi.fn((wrinkles: { set: WrinkleSet }) => {
      viewer.wrinkles?.dispose()
      viewer.wrinkles = new Wrinkles(mesh, wrinkles.set)
    }),
    setDrivers: vi.fn(),
  }
  return viewer
}

let viewer: ReturnType<typeof stubViewer>
let view: DocumentView
let document: StudioDocument
let maps: LayerMaps[]

beforeEach(() => {
  viewer = stubViewer()
  view = new DocumentView()
  document = sampleDocument()
  maps = document.layers.map((_, i) => ({ normal: randomNormals(seeded(i), SIZE) }))
  show(document)
})

function show(next: StudioDocument): void {
  view.show(viewer as unknown as Viewer, { document: next, maps, changes: new Map() })
}

const withLayer = (change: Partial<StudioLayer>): StudioDocument => {
  const [first, ...others] = document.layers
  return { ...document, layers: [{ ...first, ...change }, ...others] }
}

const scale = () => meshOf(viewer.wrinkles!).shaderInputs.normalScale.value.x

test("changing a layer's scale does not recreate wrinkles", () => {
  for (const normalScale of [0.5, 0.4, 0.3]) show(withLayer({ normalScale }))
  expect(scale()).toBe(0.3)
  show(document)
  expect(scale()).toBe(document.layers[0].normalScale)
  expect(viewer.setWrinkles).toHaveBeenCalledTimes(1)
})

test("changing a layer's kind or name recreates wrinkles", () => {
  const { kind } = document.layers[0]
  show(withLayer({ kind: kind === 'detail' ? 'replace' : 'detail' }))
  expect(viewer.setWrinkles).toHaveBeenCalledTimes(2)
})
