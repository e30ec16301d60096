import { loadFace } from '../stage/face.ts'
import type { Case, Plan, RendererKind } from './case.ts'
import { measureCrowd } from './crowd.ts'
import { createDrawer } from './draw.ts'
import { type Bench, measure } from './measure.ts'
import type { Measured } from './report.ts'
import { createScene } from './scene.ts'

/** What the page offers to the process that opened it. */
export interface BenchPage {
  /** Sets the scene up; returns the adapter's name. */
  open(renderer: RendererKind, width: number, height: number): Promise<string>
  measure(shown: Case, plan: Plan): Promise<Measured[]>
  /** Share of a crowd's frame that goes into influence maps, 0..1. */
  measureCrowd(plan: Plan): Promise<number>
}

let bench: Bench

const page: BenchPage = {
  async open(renderer, width, height) {
    const face = await loadFace('/faces/human.glb')
    const drawer = await createDrawer(renderer, width, height)
    bench = { renderer, drawer, face, ...createScene(face, width / height) }
    return drawer.adapter
  },
  measure: (shown, plan) => measure(bench, shown, plan),
  measureCrowd: (plan) => measureCrowd(bench, plan),
}
Object.assign(globalThis, { bench: page })
