import type { ReadonlySignal, Signal } from '@preact/signals'
import type { AreaConvention } from 'furrow'
import type { WrinkleMode } from 'furrow/three'
import type { RendererKind } from '../../../stage/stage.ts'
import type { AutoSettings } from '../document/document.ts'
import type { ExportOptions } from '../export/export-document.ts'
import type { ProjectEntry } from '../keep/project-store.ts'
import type { LineEditor } from '../lines/line-editor.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { AutoRun } from '../session/automatic.ts'
import type { ExportState } from '../session/exporting.ts'
import type { KeepState } from '../session/keeper.ts'
import type { LayerEditor } from '../session/layer-editor.ts'
import type { Session } from '../session/session.ts'
import type { ShapeEditor } from '../session/shape-editor.ts'
import type { Painting } from '../tools/painting.ts'
import type { Hovered } from '../viewer/hovered.ts'
import type { Look } from '../viewer/looks/looks.ts'
import type { ClipPlayer } from '../viewer/pose/clip-player.ts'
import type { Dial } from '../viewer/pose/dials.ts'
import type { Staging } from '../viewer/staging.ts'
import type { Viewer } from '../viewer/viewer.ts'

/** What panels show and request. */
export interface PanelModel {
  readonly session: Session
  readonly lines: LineEditor
  /** Areas of the document; where there is none, those of the viewer are shown. */
  readonly areas: AreaEditor
  readonly layers: LayerEditor
  readonly shapes: ShapeEditor
  readonly painting: Painting
  /** Names of the shipped faces. */
  readonly faces: ReadonlySignal<readonly string[]>
  readonly viewer: ReadonlySignal<Viewer | null>
  /** Changes whenever a number on the face may have changed: a blendshape's weight, an activation. */
  readonly frame: ReadonlySignal<number>
  /** Changes whenever the viewer's areas, mode or look have changed. */
  readonly revision: ReadonlySignal<number>
  /** The expression that the face shows or moves to; null once a slider has changed it. */
  readonly expression: ReadonlySignal<string | null>
  readonly hovered: Signal<Hovered | null>
  /** Light and turntable. */
  readonly staging: Staging
  /** Key frames. */
  readonly player: ClipPlayer
  /** Settings of the automatic wrinkles, and the run that makes them. */
  readonly auto: ReadonlySignal<AutoSettings>
  readonly autoRun: ReadonlySignal<AutoRun | null>
  readonly exporting: ReadonlySignal<ExportState | null>
  /** What the browser keeps, and whether the present work is saved. */
  readonly projects: ReadonlySignal<readonly ProjectEntry[]>
  readonly saving: ReadonlySignal<KeepState | null>
  /** The project's folder on the disk; null where it has none. */
  readonly folder: ReadonlySignal<FileSystemDirectoryHandle | null>
  /** Whether the list of shortcuts is shown. */
  readonly isListOpen: Signal<boolean>
  readonly actions: PanelActions
}

/** What a user can request. Errors are shown on the stage. */
export interface PanelActions {
  /** Runs a task, and shows its errors. */
  attempt(task: () => unknown): void
  openFiles(files: readonly File[]): void
  openFace(name: string): void
  /** Wrinkles another mesh of the avatar. */
  chooseSkin(index: number): void
  setRenderer(kind: RendererKind): void
  setMode(mode: WrinkleMode): void
  setLook(look: Look): void
  play(expression: string): void
  /** Weights of the blendshapes by name, as the user has set them. */
  pose(): ReadonlyMap<string, number>
  input(dial: Dial, value: number): void
  reset(dials: readonly Dial[]): void
  addAreaImages(files: readonly File[], convention: AreaConvention): void
  removeArea(name: string): void
  /** Moves the chosen point of the chosen line over the skin, by CSS pixels as it is seen. */
  moveLinePoint(right: number, down: number): void
  /** Makes the automatic wrinkles with these settings: a preview while a control moves, all of them when it rests. */
  previewAuto(settings: AutoSettings): void
  makeAuto(settings: AutoSettings): void
  cancelAuto(): void
  /** Makes a document of the wrinkles in the file. */
  editWrinkles(): void
  openProject(id: string): void
  /** Of a project that another tab has: goes on in a copy of it, or with itself. */
  keepCopy(): void
  takeOver(): void
  deleteProject(id: string): void
  exportFace(options: ExportOptions): void
  cancelExport(): void
  saveExport(): void
  saveProject(): void
  /** Saves the project to its folder, or to one that the user chooses. */
  saveToFolder(isOther: boolean): void
  copyLink(): void
  copyCode(text: string): void
}
