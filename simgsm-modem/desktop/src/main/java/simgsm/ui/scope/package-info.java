/** The tone scope of phone and modem. Read first {@link simgsm.ui.scope.ToneScopePanel}. Arrows: ui.scope -&gt; ui. */
package simgsm.ui.scope;
