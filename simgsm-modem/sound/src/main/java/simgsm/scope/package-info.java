/**
 * The tone scope as an instrument, without its pictures. Read first {@link simgsm.scope.ToneTracer}, which makes what it shows, then
 * {@link simgsm.scope.ScopeInstrument}. Arrows: scope -&gt; dtmf, words.
 */
package simgsm.scope;
