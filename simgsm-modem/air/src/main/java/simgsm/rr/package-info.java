/**
 * What a cell with many mobiles sends and receives on its common channels (TS 44.018): system information, and requests for a
 * channel. Read {@link simgsm.rr.SystemInformation}. Messages of dedicated channels are in {@link simgsm.air.RadioResource}.
 */
package simgsm.rr;
