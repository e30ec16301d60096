import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { reducedMotion } from '../motion.ts'
import { type LightDirection, lightPosition } from './light-direction.ts'
import type { Orbit } from './orbit.ts'
import type { Viewer } from './viewer.ts'

/** Default key light, at the upper left. */
export const KEY_LIGHT: LightDirection = { yaw: -46, pitch: 44 }
/** Light from the right at a grazing angle, which emphasises wrinkles. */
const SIDE_LIGHT: LightDirection = { yaw: 72, pitch: 36 }

export interface StagingParts {
  viewer: ReadonlySignal<Viewer | null>
  orbit(): Orbit | null
  /** Requests the next frame. */
  wake(): void
}

/** Light and turntable of the stage, kept when the face changes. */
export class Staging {
  readonly light = signal<LightDirection>(KEY_LIGHT)
  readonly turntable = signal(false)
  /** Whether the side light replaces the key light. */
  readonly isSideLit = signal(false)

  constructor({ viewer, orbit, wake }: StagingParts) {
    effect(() => {
      const light = this.isSideLit.value ? SIDE_LIGHT : this.light.value
      const stage = viewer.value?.stage
      if (!stage) return
      lightPosition(light, stage.key.position)
      wake()
    })
    effect(() => {
      viewer.value
      const camera = orbit()
      if (camera) camera.turntable = this.turntable.value
      wake()
    })
    reducedMotion.addEventListener('change', ({ matches }) => {
      if (matches) this.turntable.value = false
    })
  }
}
