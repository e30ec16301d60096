import { loadFace } from '../../stage/face.ts'
import type { RendererKind } from '../../stage/stage.ts'
import type { Case, Plan } from '../case.ts'
import type { Measured } from '../report.ts'
import type { Bench } from './bench.ts'
import { type CrowdKind, measureCrowd } from './crowd.ts'
import { measure } from './measure.ts'
import { createScene } from './scene.ts'
import { createTimedRenderer, type TimedRenderer } from './timed-renderer.ts'
import { measureUpdates, type UpdateTimes } from './updates.ts'

/** Functions of the page for the process that opens it. */
export interface BenchPage {
  /**
   * Creates the scene.
   *
   * @param url address of the face.
   */
  open(
    renderer: RendererKind,
    width: number,
    height: number,
    url: string,
  ): Promise<Pick<TimedRenderer, 'adapter' | 'timing'>>
  measure(benchCase: Case, plan: Plan): Promise<Measured[]>
  /** Measures the fraction of a crowd's frame time that influence maps take, 0..1, by round. */
  measureCrowd(kind: CrowdKind, plan: Plan): Promise<number[]>
  /** Times changes of a layer's normal map. */
  measureUpdates(plan: Plan): Promise<UpdateTimes>
}

let bench: Bench

const page: BenchPage = {
  async open(renderer, width, height, url) {
    const face = await loadFace(url)
    const timedRenderer = await createTimedRenderer(renderer, width, height)
    bench = { renderer, timedRenderer, face, ...createScene(face, width / height) }
    return { adapter: timedRenderer.adapter, timing: timedRenderer.timing }
  },
  measure: (benchCase, plan) => measure(bench, benchCase, plan),
  measureCrowd: (kind, plan) => measureCrowd(bench, kind, plan),
  measureUpdates: (plan) => measureUpdates(bench, plan),
}
Object.assign(globalThis, { bench: page })
