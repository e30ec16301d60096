/** Client hints (https://wicg.github.io/ua-client-hints), which TypeScript does not know. */
interface ClientHints {
  getHighEntropyValues(hints: string[]): Promise<{
    fullVersionList?: { brand: string; version: string }[]
    platform: string
    platformVersion?: string
  }>
}

/** Brands that browsers make up, so that nobody relies on the list: `Not;A=Brand`. */
const MADE_UP = /not.*brand/i

/** The browser and its system, with their versions; where the browser has no client hints, its user agent. */
export async function browserName(): Promise<string> {
  const { userAgentData } = navigator as { userAgentData?: ClientHints }
  if (!userAgentData) return navigator.userAgent
  const hints = ['fullVersionList', 'platformVersion']
  const {
    fullVersionList = [],
    platform,
    platformVersion = '',
  } = await userAgentData.getHighEntropyValues(hints)
  const brands = fullVersionList.filter(({ brand }) => !MADE_UP.test(brand))
  // Chrome is listed beside the Chromium that it is made of.
  const own = brands.find(({ brand }) => brand !== 'Chromium') ?? brands[0]
  if (!own) return navigator.userAgent
  return `${own.brand} ${own.version}, ${platform} ${platformVersion}`.trim()
}
