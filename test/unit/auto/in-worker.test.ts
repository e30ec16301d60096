import { autoWrinklesInWorker } from 'furrow/auto'
import { expect, it } from 'vitest'

it('names what to call where there are no web workers', async () => {
  const made = autoWrinklesInWorker({ positions: [], uvs: [], indices: [], targets: [] })
  await expect(made).rejects.toThrow(
    'autoWrinklesInWorker: there are no web workers here; call autoWrinkles of furrow/author, which runs anywhere',
  )
})
