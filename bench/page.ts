import { loadFace } from '../stage/face.ts'
import type { Case, Plan, RendererKind } from './case.ts'
import { measureCrowd } from './crowd.ts'
import { createDrawer, type Drawer } from './draw.ts'
import { type Bench, measure } from './measure.ts'
import type { Measured } from './report.ts'
import { createScene } from './scene.ts'

/** What the page offers to the process that opened it. */
export interface BenchPage {
  /**
   * Sets the scene up.
   *
   * @param url of the face.
   */
  open(
    renderer: RendererKind,
    width: number,
    height: number,
    url: string,
  ): Promise<Pick<Drawer, 'adapter' | 'timing'>>
  measure(shown: Case, plan: Plan): Promise<Measured[]>
  /** Share of a crowd's frame that goes into influence maps, 0..1. */
  measureCrowd(plan: Plan): Promise<number>
}

let bench: Bench

const page: BenchPage = {
  async open(renderer, width, height, url) {
    const face = await loadFace(url)
    const drawer = await createDrawer(renderer, width, height)
    bench = { renderer, drawer, face, ...createScene(face, width / height) }
    return { adapter: drawer.adapter, timing: drawer.timing }
  },
  measure: (shown, plan) => measure(bench, shown, plan),
  measureCrowd: (plan) => measureCrowd(bench, plan),
}
Object.assign(globalThis, { bench: page })
