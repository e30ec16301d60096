import { Activations } from './activations.ts'
import type { AreaSlots } from './area-slots.ts'

/** One face: a mesh, or one instance of it, with activations of its own. */
export class Face {
  slots: AreaSlots
  readonly activations: Activations
  /** Activations at rest, to which drivers add. */
  readonly resting: Activations

  /** @param slots of the areas, in their order. */
  constructor(slots: AreaSlots, areas: readonly { name: string; activation?: number }[]) {
    this.slots = slots
    this.activations = new Activations(areas, 'Wrinkles')
    this.resting = new Activations(areas, 'Wrinkles')
    for (const { name, activation } of areas) this.rest(name, activation ?? 0)
  }

  /** Sets an activation at rest, which shows until a driver adds to it. */
  rest(area: string, value: number): void {
    this.resting.set(area, value)
    this.activations.set(area, value)
  }

  /** Takes another list of areas; those whose names stay keep their activations. */
  rebind(slots: AreaSlots, areas: readonly { name: string }[]): void {
    this.slots = slots
    this.activations.rebind(areas)
    this.resting.rebind(areas)
  }
}
