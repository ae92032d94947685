package simgsm.center.msc;

import java.time.Instant;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import simgsm.center.subscriber.HomeRegister;
import simgsm.dtmf.ToneSet;

/**
 * What an exchange is told at its start.
 *
 * @param networkName shown on the phones
 * @param random of temporary identities and challenges
 * @param startedAt the civil time of the moment that the cores call 0 ns
 * @param home who may come
 * @param callWaiting whether a second call is offered to who is in one; else its caller hears that he is busy (17)
 * @param tones what callers are made to hear of calls that are not connected; empty when that is left to the phones
 */
public record ExchangeSettings(
        String networkName,
        RandomGenerator random,
        Instant startedAt,
        HomeRegister home,
        Optional<ToneSet> tones,
        boolean callWaiting) {
    public static final String DEFAULT_NETWORK_NAME = "SimGSM";

    /** An open network whose runs repeat with the seed, and which leaves tones to the phones. */
    public ExchangeSettings(String networkName, long seed, Instant startedAt) {
        this(networkName, new SplittableRandom(seed), startedAt, HomeRegister.OPEN, Optional.empty());
    }

    /** An exchange without call waiting. */
    public ExchangeSettings(
            String networkName, RandomGenerator random, Instant startedAt, HomeRegister home, Optional<ToneSet> tones) {
        this(networkName, random, startedAt, home, tones, false);
    }
}
