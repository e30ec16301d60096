import type { ReadonlySignal } from '@preact/signals'
import type { Downloads } from './downloads.ts'
import { filesOfInput } from './files/dropped-files.ts'
import type { Hints } from './first/hints.ts'
import type { FillOffer } from './lines/fill-offer.ts'
import type { Lines } from './lines/lines.ts'
import type { PageLink } from './link/page-link.ts'
import { readCalibration } from './live/calibrations.ts'
import type { Live } from './live/live.ts'
import type { Messages } from './messages.ts'
import type { Dialogs, PanelModel } from './panels/model.ts'
import type { AreaEditor } from './session/area-editor.ts'
import type { FaceAreas } from './session/face-areas.ts'
import type { ImageImport } from './session/image-import.ts'
import type { LayerEditor } from './session/layer-editor.ts'
import type { Opening } from './session/opening.ts'
import type { Saving } from './session/saving.ts'
import type { ShapeEditor } from './session/shape-editor.ts'
import type { TakeEditor } from './session/take-editor.ts'
import type { Workspace } from './session/workspace.ts'
import type { Painting } from './tools/painting.ts'
import type { Sculpting } from './tools/sculpting.ts'
import type { ToolChoice } from './tools/tool-choice.ts'
import { REST_POSE } from './viewer/pose/skeleton-pose.ts'
import type { ShownFace } from './viewer/shown-face.ts'
import type { SkeletonOverlay } from './viewer/skeleton/skeleton-overlay.ts'
import type { ViewerHost } from './viewer/viewer-host.ts'

/** Parts of the application that panels show and control. */
export interface PanelParts {
  workspace: Workspace
  saving: Saving
  face: ShownFace
  skeleton: SkeletonOverlay
  lines: Lines
  areas: AreaEditor
  faceAreas: FaceAreas
  images: ImageImport
  layers: LayerEditor
  shapes: ShapeEditor
  painting: Painting
  fill: FillOffer
  sculpting: Sculpting
  tools: ToolChoice
  opening: Opening
  host: ViewerHost
  downloads: Downloads
  link: PageLink
  messages: Messages
  faces: ReadonlySignal<readonly string[]>
  dialogs: Dialogs
  hints: Hints
  live: Live
  takes: TakeEditor
}

export function panelModel(parts: PanelParts): PanelModel {
  const {
    workspace,
    saving,
    face,
    skeleton,
    lines,
    areas,
    faceAreas,
    images,
    layers,
    shapes,
    painting,
    fill,
    tools,
  } = parts
  const { sculpting, opening, host, downloads, link, messages, faces, dialogs, hints, live, takes } = parts
  const { session, automatic, exporting, keeping, settings } = workspace
  const { viewer, frame, revision, expression, bodyPose, hovered, staging, player, meshes, pictures } = face
  return {
    session,
    lines: lines.editor,
    areas,
    images,
    layers,
    shapes,
    painting,
    fill,
    sculpting,
    tools,
    auto: settings,
    source: workspace.source,
    autoRun: automatic.run,
    isBeginning: workspace.isBeginning,
    exporting: exporting.state,
    projects: keeping.projects,
    saving: keeping.state,
    folder: saving.folder,
    dialogs,
    hints,
    faces,
    viewer,
    frame,
    revision,
    expression,
    bodyPose,
    hovered,
    staging,
    meshes,
    pictures,
    isSkeletonShown: skeleton.isOn,
    player,
    live,
    takes,
    actions: {
      attempt: (task) => void messages.attempt(task),
      openFiles: (files) => opening.openFiles(async () => filesOfInput(files)),
      openFace: (name) => opening.openFace(name),
      chooseSkin: async (skin) => {
        await opening.open(async (shown) => ({ ...shown!, skin }))
        if (face.bodyPose.peek()) face.playPose(REST_POSE)
        face.frameSkin()
      },
      setRenderer: (kind) => {
        face.settle()
        return host.open(kind)
      },
      setMode: (mode) =>
        face.change((shown) => {
          shown.mode = mode
        }),
      setLook: (look) =>
        face.change((shown) => {
          shown.look = look
        }),
      play: (name) => face.play(name),
      playPose: (name) => face.playPose(name),
      startLive: () => void messages.attempt(() => live.start()),
      saveCalibration: () => downloads.saveCalibration(live),
      loadCalibration: (file) =>
        void messages.attempt(async () => live.setCalibration(await readCalibration(file))),
      pose: () => face.pose(),
      input: (dial, value) => face.input(dial, value),
      reset: (dials) => face.reset(dials),
      addAreaImages: (files) => faceAreas.add(files),
      removeArea: (name) => faceAreas.remove(name),
      selectRegion: (name) => {
        // The tools for lines have no settings of a region.
        if (name !== null && tools.mode.peek() === 'lines') tools.choose('select')
        lines.editor.choose(null)
        areas.choose(name)
      },
      moveLinePoint: (right, down) => void messages.attempt(() => lines.movePoint(right, down)),
      previewAuto: (next) => void messages.attempt(() => workspace.previewAuto(next)),
      makeAuto: (next) => void messages.attempt(() => workspace.makeAuto(next)),
      cancelAuto: () => workspace.cancelAuto(),
      editWrinkles: () => void messages.attempt(() => workspace.editWrinkles()),
      openProject: (id) => opening.openProject(id),
      keepCopy: () => void messages.attempt(() => keeping.copy()),
      takeOver: () => opening.takeOver(),
      deleteProject: (id) => void messages.attempt(() => keeping.delete(id)),
      exportFace: (options) => void downloads.exportFace(options),
      cancelExport: () => exporting.cancel(),
      savePreset: () => downloads.savePreset(host.viewer),
      saveProject: () => void downloads.saveProject(),
      saveToFolder: (isOtherFolder) => void downloads.saveToFolder(isOtherFolder),
      copyCode: (text) => void downloads.copyCode(text),
      savePicture: () => void downloads.savePicture(host.viewer, expression.peek()),
      saveUvLayout: () => void downloads.saveUvLayout(host.viewer),
      copyLink: () => void messages.attempt(() => link.copy()),
    },
  }
}
