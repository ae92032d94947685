package simgsm.center.bsc;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import simgsm.abis.CcmMessage;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.subscriber.HomeRegister;

/** An exchange with towers and a clock moved by hand. */
final class TowerStage {
    static final String IMEI = "4a09512430325781";
    static final String THIRD_IMEI = "3a25900910674199";
    static final String OTHER_IMEI = "3a25900910674118";

    final List<ExchangeEvent> events = new ArrayList<>();
    private final Deque<Long> uncommitted = new ArrayDeque<>();
    long nowNanos;
    final Exchange exchange;

    TowerStage() {
        this(HomeRegister.OPEN);
    }

    TowerStage(HomeRegister home) {
        exchange = new Exchange(
                new ExchangeSettings(
                        "SimGSM",
                        new SplittableRandom(1),
                        Instant.parse("2026-11-21T12:00:00Z"),
                        home,
                        Optional.empty()),
                (ticket, entries) -> uncommitted.add(ticket),
                events::add);
    }

    /** The towers of the recorded dialogues. */
    TestTower west() {
        return tower("west arfcn=100 bsic=10 lac=1 cell=6969 tch=7", "6969/0/0");
    }

    TestTower east() {
        return tower("east arfcn=110 bsic=11 lac=1 cell=6970 tch=7", "6970/0/0");
    }

    TestTower tower(String unitName, String unitId) {
        return tower(unitName, unitId, unitName.split(" ", 2)[0]);
    }

    TestTower tower(String unitName, String unitId, String address) {
        return new TestTower(
                this, unitName.split(" ", 2)[0], address, new CcmMessage.IdentityResponse(unitName, "", unitId));
    }

    void commit() {
        for (Long ticket = uncommitted.poll(); ticket != null; ticket = uncommitted.poll()) {
            exchange.committed(nowNanos, ticket, true);
        }
    }

    void passMillis(long millis) {
        nowNanos += Duration.ofMillis(millis).toNanos();
        exchange.advance(nowNanos);
        commit();
    }
}
