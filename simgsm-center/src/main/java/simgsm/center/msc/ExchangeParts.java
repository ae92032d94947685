package simgsm.center.msc;

import java.util.Set;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.timer.Timers;

/**
 * What every link shares.
 *
 * @param links all open links
 * @param settlement links on which something has changed since the exchange last rested
 */
record ExchangeParts(
        Timers timers,
        Trace trace,
        Mobility mobility,
        ShortMessageCenter shortMessageCenter,
        Set<Link> links,
        Set<Link> settlement) {}
