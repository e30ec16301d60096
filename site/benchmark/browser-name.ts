/** Client hints (https://wicg.github.io/ua-client-hints), which TypeScript's types of the DOM lack. */
interface ClientHints {
  getHighEntropyValues(hints: string[]): Promise<{
    fullVersionList?: { brand: string; version: string }[]
    platform: string
    platformVersion?: string
  }>
}

/** Matches the placeholder that Chromium adds to its list of brands, e.g. `Not;A=Brand`. */
const PLACEHOLDER_BRAND = /not.*brand/i

/** Returns the browser and the operating system with their versions. Without client hints, returns the user agent. */
export async function browserName(): Promise<string> {
  const { userAgentData } = navigator as { userAgentData?: ClientHints }
  if (!userAgentData) return navigator.userAgent
  const hints = ['fullVersionList', 'platformVersion']
  const {
    fullVersionList = [],
    platform,
    platformVersion = '',
  } = await userAgentData.getHighEntropyValues(hints)
  const brands = fullVersionList.filter(({ brand }) => !PLACEHOLDER_BRAND.test(brand))
  // Browsers based on Chromium list both Chromium and their own brand.
  const own = brands.find(({ brand }) => brand !== 'Chromium') ?? brands[0]
  if (!own) return navigator.userAgent
  return `${own.brand} ${own.version}, ${platform} ${platformVersion}`.trim()
}
