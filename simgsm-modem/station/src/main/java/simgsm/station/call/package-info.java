/** The mobile's call (TS 24.008, 5): call control, signalled keys, speech. Read first: {@link simgsm.station.call.MobileCall}. */
package simgsm.station.call;
