/**
 * Messages on the common channels of a cell (TS 44.018): system information, and requests for a channel. Read {@link
 * simgsm.rr.SystemInformation}. Messages of dedicated channels are in {@link simgsm.air.RadioResource}.
 */
package simgsm.rr;
