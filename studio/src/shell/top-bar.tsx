import { historyLabel, MODES, PAGE } from '../labels/page.ts'
import { FILE } from '../labels/project.ts'
import { KeepStatus } from '../panels/keeping/keep-status.tsx'
import type { PanelModel } from '../panels/model.ts'
import { MODE_NAMES, type Mode } from '../tools/tool-choice.ts'
import { Icon, type IconName } from '../ui/icon.tsx'
import { ExportCard } from './export-card.tsx'
import { ImageQuestion } from './image-question.tsx'
import { Preferences } from './preferences.tsx'
import { ProjectCard } from './project-card.tsx'
import { ShareCard } from './share-card.tsx'
import { ShortcutList } from './shortcut-list.tsx'

const MODE_OPTIONS = MODE_NAMES.map((value) => ({ value, label: MODES[value] }))

/** Bar at the top: the project, undo, the modes, sharing and export. */
export function TopBar({ model }: { model: PanelModel }) {
  const { session, tools, dialogs, actions } = model
  const { undoLabel, redoLabel } = session
  const document = session.document.value
  return (
    <>
      <div class="bar">
        <h1 class="hidden">{PAGE.title}</h1>
        <ProjectCard model={model} />
        <KeepStatus model={model} />
        <History label={FILE.undo} icon="undo" step={undoLabel.value} onPress={() => session.undo()} />
        <History label={FILE.redo} icon="redo" step={redoLabel.value} onPress={() => session.redo()} />
        <Modes mode={tools.mode.value} onChange={(mode) => tools.chooseMode(mode)} />
        <ShareCard actions={actions} />
        {document && <ExportCard model={model} document={document} />}
        <button
          type="button"
          class="plain keys"
          aria-label={FILE.shortcuts}
          title={FILE.shortcutsHint}
          onClick={() => {
            dialogs.shortcuts.value = true
          }}
        >
          ?
        </button>
        <button
          type="button"
          class="plain"
          aria-label={FILE.preferences}
          title={FILE.preferences}
          onClick={() => {
            dialogs.preferences.value = true
          }}
        >
          <Icon name="gear" />
        </button>
      </div>
      <ShortcutList isOpen={dialogs.shortcuts} />
      <Preferences model={model} />
      <ImageQuestion model={model} />
    </>
  )
}

interface HistoryProps {
  label: string
  icon: IconName
  /** Step that the button reverts or repeats. Undefined disables the button. */
  step: string | undefined
  onPress(): void
}

/** A button with `aria-disabled` keeps the focus, so that users can undo everything by pressing a key repeatedly. */
function History({ label, icon, step, onPress }: HistoryProps) {
  return (
    <button
      type="button"
      class="plain"
      aria-label={label}
      aria-disabled={!step}
      title={historyLabel(label, step)}
      onClick={onPress}
    >
      <Icon name={icon} />
    </button>
  )
}

function Modes({ mode, onChange }: { mode: Mode; onChange(mode: Mode): void }) {
  return (
    <fieldset class="segments modes" aria-label={PAGE.mode}>
      {MODE_OPTIONS.map(({ value, label }) => (
        <label key={value}>
          <input type="radio" name="mode" checked={value === mode} onChange={() => onChange(value)} />
          <span>{label}</span>
        </label>
      ))}
    </fieldset>
  )
}
