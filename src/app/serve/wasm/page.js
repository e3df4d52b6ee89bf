// The modules of the page with the engine inside, for one_file.mjs.
import './local.js';
import '../page/main.js';
