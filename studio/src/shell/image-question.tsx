import { IMAGE } from '../labels/images.ts'
import { REGION } from '../labels/regions.ts'
import { Check } from '../panels/controls/check.tsx'
import { Choice } from '../panels/controls/choice.tsx'
import type { PanelModel } from '../panels/model.ts'
import { IMAGE_KINDS } from '../session/image-kind.ts'
import { Dialog } from '../ui/dialog.tsx'

const KINDS = IMAGE_KINDS.map((value) => ({ value, label: IMAGE[value] }))

/** Dialog that asks what dropped images are: regions, or maps of a layer. */
export function ImageQuestion({ model: { images, areas, actions } }: { model: PanelModel }) {
  const asked = images.asked.value
  return (
    <Dialog title={asked.length > 1 ? IMAGE.questions : IMAGE.question} isOpen={images.isAsking}>
      <form
        onSubmit={(event) => {
          event.preventDefault()
          actions.attempt(() => images.add())
        }}
      >
        {asked.map((image) => (
          <div key={image.url} class="asked">
            <img src={image.url} alt="" />
            <Choice
              label={image.file.name}
              options={KINDS}
              columns={2}
              value={image.kind}
              onChange={(kind) => images.setKind(image, kind)}
            />
          </div>
        ))}
        {asked.some(({ kind }) => kind === 'mask') && <Check value={areas.isPaper}>{REGION.paper}</Check>}
        <div class="work">
          {/* The focus on this button lets Enter accept the guesses. */}
          <button type="submit" class="main" data-autofocus>
            {IMAGE.add}
          </button>
        </div>
      </form>
    </Dialog>
  )
}
