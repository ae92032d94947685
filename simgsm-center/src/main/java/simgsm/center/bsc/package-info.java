/**
 * The base station controller: towers speak RSL over the centre's port, channels are given out, calls are handed over. Each mobile
 * on a tower is a {@link simgsm.center.msc.link.Link} of the exchange.
 *
 * <pre>
 *   BaseStationController -> TowerControl -> DedicatedChannel -> RadioConnection -> TowerMobile = Link of the exchange
 * </pre>
 *
 * <p>Read first: {@link simgsm.center.bsc.BaseStationController}, then {@link simgsm.center.bsc.ConnectionTable}.
 */
package simgsm.center.bsc;
