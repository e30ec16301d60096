import { canWriteFolders } from '../../keep/disk-folder.ts'
import { KEEPING, saveToLabel } from '../../labels/project.ts'
import type { PanelModel } from '../model.ts'

/** Buttons that save the project as a .zip file or, if the browser can write folders, as a folder. */
export function SaveProject({ model: { folder, actions } }: { model: PanelModel }) {
  const known = folder.value
  return (
    <div class="add">
      <button type="button" onClick={actions.saveProject}>
        {KEEPING.saveProject}
      </button>
      {canWriteFolders() && known && (
        <button type="button" onClick={() => actions.saveToFolder(false)}>
          {saveToLabel(known.name)}
        </button>
      )}
      {canWriteFolders() && (
        <button type="button" onClick={() => actions.saveToFolder(true)}>
          {known ? KEEPING.saveToOtherFolder : KEEPING.saveToFolder}
        </button>
      )}
    </div>
  )
}
