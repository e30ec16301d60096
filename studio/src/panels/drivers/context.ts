import type { ReadonlySignal } from '@preact/signals'
import type { Contribution } from 'furrow/internal'
import type { DriverEditor } from '../../session/driver-editor.ts'
import type { PanelModel } from '../model.ts'

/** What the forms of drivers show and change. */
export interface DriverContext {
  readonly model: PanelModel
  readonly editor: DriverEditor
  /** Name of the area. */
  readonly area: string
  /** Names of the face's blendshapes, and of the document's areas. */
  readonly targets: readonly string[]
  readonly areas: readonly string[]
  /** Blendshapes that are set, with their weights. */
  pose(): Map<string, number>
  /** What each driver of the document gives in this frame, and at a pace at which it can be read. */
  readonly now: ReadonlySignal<readonly (Contribution | null)[]>
  readonly slow: ReadonlySignal<readonly (Contribution | null)[]>
}

/** What a form changes: one driver, by its index in the document. */
export interface FormProps<Driver> {
  readonly driver: Driver
  readonly index: number
  readonly context: DriverContext
}
