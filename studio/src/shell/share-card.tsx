import { useSignal } from '@preact/signals'
import { FILE } from '../labels/project.ts'
import type { PanelActions } from '../panels/model.ts'
import { Popover } from '../ui/popover.tsx'

/** Button with a card that copies a link or saves a picture. Both close the card, which would cover the face. */
export function ShareCard({ actions }: { actions: PanelActions }) {
  const isOpen = useSignal(false)
  const run = (action: () => void) => {
    isOpen.value = false
    action()
  }
  return (
    <Popover label={FILE.share} placement="bottom-end" button={FILE.share} isOpen={isOpen}>
      <button type="button" title={FILE.copyLinkHint} onClick={() => run(actions.copyLink)}>
        {FILE.copyLink}
      </button>
      <button type="button" onClick={() => run(actions.savePicture)}>
        {FILE.screenshot}
      </button>
    </Popover>
  )
}
