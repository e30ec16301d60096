import type { ReadonlySignal } from '@preact/signals'
import type { Contribution } from 'furrow/internal'
import type { DriverEditor } from '../../session/driver-editor.ts'
import type { PanelModel } from '../model.ts'

/** Data that all forms for the drivers of an area need. */
export interface DriverContext {
  readonly model: PanelModel
  readonly editor: DriverEditor
  readonly area: string
  /** Names of the face's blendshapes and of the document's areas. */
  readonly targets: readonly string[]
  readonly areas: readonly string[]
  /** Returns the blendshapes whose weights are not 0, with their weights. */
  pose(): Map<string, number>
  /** Contribution of each driver in the document, updated each frame. */
  readonly now: ReadonlySignal<readonly (Contribution | null)[]>
  /** Contribution of each driver, updated so slowly that it can be read. */
  readonly slow: ReadonlySignal<readonly (Contribution | null)[]>
}

/** Props of a form for a driver. `index` is the driver's index in the document. */
export interface FormProps<Driver> {
  readonly driver: Driver
  readonly index: number
  readonly context: DriverContext
}
