/** Vite options that resolve the workspace's packages to sources instead of builds, in browsers and in Node. */
export const SOURCES: {
  resolve: { alias: Record<string, string>; conditions: string[] }
  ssr: { resolve: { conditions: string[] } }
}
