import type { Theme } from 'vitepress'
import DefaultTheme from 'vitepress/theme-without-fonts'
import './style.css'
import ExampleGallery from './ExampleGallery.vue'
import FirstPage from './FirstPage.vue'
import Layout from './Layout.vue'
import LiveExample from './LiveExample.vue'

const theme: Theme = {
  extends: DefaultTheme,
  Layout,
  enhanceApp({ app }) {
    app.component('ExampleGallery', ExampleGallery)
    app.component('FirstPage', FirstPage)
    app.component('LiveExample', LiveExample)
  },
}
export default theme
