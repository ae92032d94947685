/** Short messages of the mobile (TS 24.011, TS 23.040) in both directions, and cell broadcast. Read first: {@link simgsm.station.sms.ShortMessages}. */
package simgsm.station.sms;
