/**
 * RSL (TS 48.058) between a base station and its controller, as messages of typed elements. Read {@link
 * simgsm.abis.rsl.RslPdu} first.
 */
package simgsm.abis.rsl;
