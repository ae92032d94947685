package simgsm.center.msc;

import java.time.Instant;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import simgsm.air.Msisdn;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.center.subscriber.HomeRegister;
import simgsm.tone.ToneSet;

/**
 * Settings of an exchange.
 *
 * @param networkName shown on the phones
 * @param random source of temporary identities and challenges
 * @param startedAt civil time at 0 ns of the exchange's time
 * @param home subscribers who may register
 * @param tones call progress tones that the network plays to callers; empty if the phones make them
 * @param callWaiting true to offer a second call to a phone in a call; else it is refused with cause 17
 * @param language of the USSD texts
 * @param speaksUdp true to ask terminals for speech as RTP over UDP
 * @param setupNanos T303: time for a called mobile to answer SETUP
 * @param emergencyNumber who answers 112 and 911; empty for a notice
 * @param handover decides when a call over towers moves to another cell
 */
public record ExchangeSettings(
        String networkName,
        RandomGenerator random,
        Instant startedAt,
        HomeRegister home,
        Optional<ToneSet> tones,
        boolean callWaiting,
        Locale language,
        boolean speaksUdp,
        long setupNanos,
        Optional<Msisdn> emergencyNumber,
        HandoverAlgorithm handover) {
    public static final String DEFAULT_NETWORK_NAME = "SimGSM";

    /** An open network without tones, reproducible by its seed. */
    public ExchangeSettings(String networkName, long seed, Instant startedAt) {
        this(networkName, new SplittableRandom(seed), startedAt, HomeRegister.OPEN, Optional.empty());
    }

    /** An exchange without call waiting, in English, with the usual T303. */
    public ExchangeSettings(
            String networkName, RandomGenerator random, Instant startedAt, HomeRegister home, Optional<ToneSet> tones) {
        this(
                networkName,
                random,
                startedAt,
                home,
                tones,
                false,
                Locale.ENGLISH,
                false,
                NetworkTimer.T303.nanos(),
                Optional.empty(),
                HandoverAlgorithm.STANDARD);
    }
}
