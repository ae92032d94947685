/**
 * Components of supplementary services (TS 24.080, 3): operations, results and errors in BER, and the texts of USSD.
 * Their messages are in {@link simgsm.air.SupplementaryService}.
 *
 * <p>Read first: {@link simgsm.ss.Component}, then {@link simgsm.ss.UssdText}.
 */
package simgsm.ss;
