/** Supplementary services of the mobile: USSD in both directions (TS 24.090). Read first: {@link simgsm.station.ss.MobileUssd}. */
package simgsm.station.ss;
