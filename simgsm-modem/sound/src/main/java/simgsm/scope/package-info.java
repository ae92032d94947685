/** The tone scope as an instrument, without its pictures. Read first {@link simgsm.scope.ScopeInstrument}. Arrows: scope -&gt; dtmf. */
package simgsm.scope;
