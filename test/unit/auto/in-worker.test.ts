import { autoWrinklesInWorker } from 'furrow/auto'
import { expect, it } from 'vitest'

it('names the function to call in environments without web workers', async () => {
  const made = autoWrinklesInWorker({ positions: [], uvs: [], indices: [], targets: [] })
  await expect(made).rejects.toThrow(
    'autoWrinklesInWorker: web workers are not supported here; call autoWrinkles of furrow/author, which needs no worker',
  )
})
