import { afterEach, expect, it, vi } from 'vitest'
import { browserName } from '../../../site/benchmark/browser-name.ts'

afterEach(() => vi.unstubAllGlobals())

const brand = (name: string, version: string) => ({ brand: name, version })
const withHints = (fullVersionList: object[] | undefined) =>
  vi.stubGlobal('navigator', {
    userAgent: 'agent',
    userAgentData: {
      getHighEntropyValues: async () => ({ fullVersionList, platform: 'Windows', platformVersion: '15.0.0' }),
    },
  })

it('is taken from the client hints, without the fake brand that browsers add', async () => {
  withHints([brand('Not;A=Brand', '8.0'), brand('Chromium', '141.0.1'), brand('Google Chrome', '141.0.2')])
  expect(await browserName()).toBe('Google Chrome 141.0.2, Windows 15.0.0')
  withHints([brand('Chromium', '141.0.1'), brand('Not(A:Brand', '24')])
  expect(await browserName()).toBe('Chromium 141.0.1, Windows 15.0.0')
})

it('is the user agent if there are no client hints', async () => {
  vi.stubGlobal('navigator', { userAgent: 'Mozilla/5.0 of a browser' })
  expect(await browserName()).toBe('Mozilla/5.0 of a browser')
  withHints(undefined)
  expect(await browserName()).toBe('agent')
})
