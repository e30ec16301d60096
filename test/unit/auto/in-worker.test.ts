import { autoWrinklesInWorker } from 'furrow/auto'
import { expect, it } from 'vitest'

it('the error without web workers names the function to call instead', async () => {
  const made = autoWrinklesInWorker({ positions: [], uvs: [], indices: [], targets: [] })
  await expect(made).rejects.toThrow(
    'autoWrinklesInWorker: web workers are not supported here; call autoWrinkles of furrow/author, which needs no worker',
  )
})
