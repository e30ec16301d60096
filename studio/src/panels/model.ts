import type { ReadonlySignal, Signal } from '@preact/signals'
import type { WrinkleMode } from 'furrow/three'
import type { RendererKind } from '../../../stage/stage.ts'
import type { AutoSettings } from '../document/document.ts'
import type { ExportOptions } from '../export/export-document.ts'
import type { Hints } from '../first/hints.ts'
import type { ProjectEntry } from '../keep/project-store.ts'
import type { FillOffer } from '../lines/fill-offer.ts'
import type { LineEditor } from '../lines/line-editor.ts'
import type { Live } from '../live/live.ts'
import type { SkinSource } from '../open/skin-source.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { AutoRun } from '../session/automatic.ts'
import type { ExportState } from '../session/exporting.ts'
import type { ImageImport } from '../session/image-import.ts'
import type { KeepState } from '../session/keeper.ts'
import type { LayerEditor } from '../session/layer-editor.ts'
import type { Session } from '../session/session.ts'
import type { ShapeEditor } from '../session/shape-editor.ts'
import type { TakeEditor } from '../session/take-editor.ts'
import type { Painting } from '../tools/painting.ts'
import type { Sculpting } from '../tools/sculpting.ts'
import type { ToolChoice } from '../tools/tool-choice.ts'
import type { Hovered } from '../viewer/hovered.ts'
import type { Look } from '../viewer/looks/look.ts'
import type { MeshVisibility } from '../viewer/mesh-visibility.ts'
import type { ClipPlayer } from '../viewer/pose/clip-player.ts'
import type { Dial } from '../viewer/pose/dials.ts'
import type { PosePictures } from '../viewer/pose/pose-pictures.ts'
import type { Staging } from '../viewer/staging.ts'
import type { Viewer } from '../viewer/viewer.ts'

/** Dialogs of the page. */
export interface Dialogs {
  readonly shortcuts: Signal<boolean>
  readonly preferences: Signal<boolean>
}

/** State that the panels show, and actions that they offer. */
export interface PanelModel {
  readonly session: Session
  readonly lines: LineEditor
  /** Editor of the document's areas. Without a document, panels show the areas of `viewer`. */
  readonly areas: AreaEditor
  /** Question about dropped images. */
  readonly images: ImageImport
  readonly layers: LayerEditor
  readonly shapes: ShapeEditor
  readonly painting: Painting
  /** Offer to fill painted skin with lines. */
  readonly fill: FillOffer
  readonly sculpting: Sculpting
  readonly tools: ToolChoice
  /** Names of the shipped faces. */
  readonly faces: ReadonlySignal<readonly string[]>
  readonly viewer: ReadonlySignal<Viewer | null>
  /** Counter that increases when a weight or an activation may have changed. */
  readonly frame: ReadonlySignal<number>
  /** Counter that increases when the viewer's areas, mode or look change. */
  readonly revision: ReadonlySignal<number>
  /** Expression that the face has or moves to. Null after a slider has changed the face. */
  readonly expression: ReadonlySignal<string | null>
  /** Pose of joints that the avatar has or moves to: the name of a pose, or `REST_POSE`. Null after joints were turned otherwise. */
  readonly bodyPose: ReadonlySignal<string | null>
  readonly hovered: Signal<Hovered | null>
  /** Light and turntable. */
  readonly staging: Staging
  readonly meshes: MeshVisibility
  readonly pictures: PosePictures
  /** Whether the skeleton is drawn over the stage. */
  readonly isSkeletonShown: Signal<boolean>
  readonly player: ClipPlayer
  readonly live: Live
  readonly takes: TakeEditor
  readonly auto: ReadonlySignal<AutoSettings>
  /** Skin with its blendshapes and joints. Null if it cannot wrinkle, or while the wrinkles of the file are shown. */
  readonly source: ReadonlySignal<SkinSource | null>
  /** Progress of making automatic wrinkles, or null. */
  readonly autoRun: ReadonlySignal<AutoRun | null>
  /** Whether the first wrinkles of an avatar are made and drawn. */
  readonly isBeginning: ReadonlySignal<boolean>
  readonly exporting: ReadonlySignal<ExportState | null>
  readonly projects: ReadonlySignal<readonly ProjectEntry[]>
  /** State of saving in the browser, or null while there is nothing to save. */
  readonly saving: ReadonlySignal<KeepState | null>
  /** Folder on disk to which the user saved the project, or null. */
  readonly folder: ReadonlySignal<FileSystemDirectoryHandle | null>
  readonly dialogs: Dialogs
  readonly hints: Hints
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
  /** @param pose name of a pose of joints, or `REST_POSE`. */
  playPose(pose: string): void
  /** Starts the chosen source of live face scores. */
  startLive(): void
  /** Saves the calibration of the current sender as a file. */
  saveCalibration(): void
  loadCalibration(file: File): void
  /** Ends the preview of an area or blendshape. Then returns the weights of all blendshapes. The keys are their names. */
  pose(): ReadonlyMap<string, number>
  input(dial: Dial, value: number): void
  reset(dials: readonly Dial[]): void
  addAreaImages(files: readonly File[]): void
  removeArea(name: string): void
  /** Selects a region, or the whole face if `name` is null. */
  selectRegion(name: string | null): void
  /** Moves the chosen point of the chosen line over the skin, by a distance on the screen, CSS pixels. */
  moveLinePoint(right: number, down: number): void
  /** Shows a preview of automatic wrinkles, while a slider moves. */
  previewAuto(settings: AutoSettings): void
  /** Makes automatic wrinkles with maps of full size. */
  makeAuto(settings: AutoSettings): void
  cancelAuto(): void
  /** Saves the settings of automatic wrinkles as a file, for other avatars. */
  savePreset(): void
  /** Makes a document from the wrinkles in the avatar's file, so that they can be edited. */
  editWrinkles(): void
  openProject(id: string): void
  /** Continues in a copy of a project that is open in another tab. */
  keepCopy(): void
  /** Takes over the project from another tab that has it open. */
  takeOver(): void
  deleteProject(id: string): void
  /** Packs the avatar with its wrinkles and saves the file. */
  exportFace(options: ExportOptions): void
  cancelExport(): void
  saveProject(): void
  /** Saves the project to its folder on disk. Asks for a folder if the project has none, or if `isOtherFolder` is true. */
  saveToFolder(isOtherFolder: boolean): void
  copyLink(): void
  /** Saves the stage as an image. */
  savePicture(): void
  saveUvLayout(): void
  copyCode(text: string): void
}
