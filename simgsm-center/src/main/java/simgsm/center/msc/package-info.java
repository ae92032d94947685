/**
 * The exchange: one deterministic core of the packages below it, and the views on it for the operator.
 *
 * <pre>
 *   msc -> msc.sms, msc.ss, msc.call -> msc.mobility -> msc.link -> subscriber
 *    |        |                                            ^
 *    |      smsc                                           |
 *   bsc ---------------------------------------------------+
 * </pre>
 *
 * <p>Read first: {@link simgsm.center.msc.Exchange}, then the package of the procedure in question.
 */
package simgsm.center.msc;
