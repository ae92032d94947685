/**
 * M3, the SMS/Phone centre, as a program: command line, console, data directory, window.
 *
 * <p>Packages, arrows point down only:
 *
 * <pre>
 *   center
 *    |    \
 *   net    ui
 *    |    /
 *   msc
 *    |  \  \
 *    |  smpp subscriber
 *    |  /
 *   smsc
 *    |
 *   timer
 * </pre>
 *
 * <p>Read first: {@link simgsm.center.app.Center}; for what the centre does, {@link
 * simgsm.center.msc.Exchange}.
 */
package simgsm.center;
