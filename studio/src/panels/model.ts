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

/** State and actions of the panels. */
export interface PanelModel {
  readonly session: Session
  readonly lines: LineEditor
  /** Areas of the document. Without a document, panels show the viewer's areas. */
  readonly areas: AreaEditor
  readonly layers: LayerEditor
  readonly shapes: ShapeEditor
  readonly painting: Painting
  /** Names of the shipped faces. */
  readonly faces: ReadonlySignal<readonly string[]>
  readonly viewer: ReadonlySignal<Viewer | null>
  /** Changes when a weight or an activation may have changed. */
  readonly frame: ReadonlySignal<number>
  /** Changes when the viewer's areas, mode or look change. */
  readonly revision: ReadonlySignal<number>
  /** Expression shown or approached, null after a slider changed it. */
  readonly expression: ReadonlySignal<string | null>
  readonly hovered: Signal<Hovered | null>
  /** Light and turntable. */
  readonly staging: Staging
  /** Player of key frames. */
  readonly player: ClipPlayer
  /** Settings and current run of automatic wrinkles. */
  readonly auto: ReadonlySignal<AutoSettings>
  readonly autoRun: ReadonlySignal<AutoRun | null>
  readonly exporting: ReadonlySignal<ExportState | null>
  /** Projects stored in the browser, and the state of saving. */
  readonly projects: ReadonlySignal<readonly ProjectEntry[]>
  readonly saving: ReadonlySignal<KeepState | null>
  /** Project folder on disk, or null. */
  readonly folder: ReadonlySignal<FileSystemDirectoryHandle | null>
  /** Whether the list of shortcuts is open. */
  readonly isListOpen: Signal<boolean>
  readonly actions: PanelActions
}

/** Actions of the user. Errors are shown on the stage. */
export interface PanelActions {
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): void
  openFiles(files: readonly File[]): void
  openFace(name: string): void
  /** Chooses another mesh of the avatar as the skin. */
  chooseSkin(index: number): void
  setRenderer(kind: RendererKind): void
  setMode(mode: WrinkleMode): void
  setLook(look: Look): void
  play(expression: string): void
  /** Returns blendshape weights by name, as set by the user. */
  pose(): ReadonlyMap<string, number>
  input(dial: Dial, value: number): void
  reset(dials: readonly Dial[]): void
  addAreaImages(files: readonly File[], convention: AreaConvention): void
  removeArea(name: string): void
  /** Moves the chosen point of the chosen line on screen, by CSS pixels. */
  moveLinePoint(right: number, down: number): void
  /** Makes automatic wrinkles: previews while a control moves, the full result on release. */
  previewAuto(settings: AutoSettings): void
  makeAuto(settings: AutoSettings): void
  cancelAuto(): void
  /** Makes the wrinkles of the file editable. */
  editWrinkles(): void
  openProject(id: string): void
  /** For a project that is open in another tab: continues in a copy, or takes it over. */
  keepCopy(): void
  takeOver(): void
  deleteProject(id: string): void
  exportFace(options: ExportOptions): void
  cancelExport(): void
  saveExport(): void
  saveProject(): void
  /** Saves the project to its folder, or to a chosen one. */
  saveToFolder(isOtherFolder: boolean): void
  copyLink(): void
  copyCode(text: string): void
}
