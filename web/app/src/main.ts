import { mount } from "svelte";
import "../../components/palette.css";
import "./styles/base.css";
import "../../components/drawings.css";
import "../../components/charts.css";
import App from "./App.svelte";

const target = document.getElementById("app");
if (target) mount(App, { target });
