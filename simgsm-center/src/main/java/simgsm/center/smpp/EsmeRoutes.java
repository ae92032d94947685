package simgsm.center.smpp;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryPort;
import simgsm.center.smsc.DeliveryReceipt;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.Recipient;

/** The short message centre's way to applications: by the number that they serve, receipts by system id. */
public final class EsmeRoutes implements DeliveryPort {
    private static final int MAX_REMEMBERED = 100_000;

    private final Map<String, Route> bySystemId = new HashMap<>();
    private final Map<Msisdn, Route> byNumber = new HashMap<>();
    private final Map<AddressRange, Route> byRange = new LinkedHashMap<>();
    /** Which range a number fell into; ranges are slow to search. Forgotten when an application comes or goes. */
    private final Map<Msisdn, Optional<Route>> found = new HashMap<>();

    EsmeRoutes() {}

    /** Whether an application serves just this number. */
    public boolean serveExactly(Msisdn number) {
        return byNumber.containsKey(number);
    }

    /** Whether an application serves this number, alone or among others. */
    public boolean serve(Msisdn number) {
        return routeOf(number).isPresent();
    }

    boolean serve(Recipient receiver) {
        return routeOf(receiver).isPresent();
    }

    void add(EsmeSession session, Optional<AddressRange> range) {
        found.clear();
        bySystemId.computeIfAbsent(session.systemId(), id -> new Route()).add(session);
        range.ifPresent(numbers -> {
            Route route = numbers.exact().isPresent()
                    ? byNumber.computeIfAbsent(numbers.exact().get(), number -> new Route())
                    : byRange.computeIfAbsent(numbers, each -> new Route());
            route.add(session);
        });
    }

    void remove(EsmeSession session, Optional<AddressRange> range) {
        found.clear();
        removeFrom(bySystemId, session.systemId(), session);
        range.ifPresent(numbers -> {
            if (numbers.exact().isPresent()) {
                removeFrom(byNumber, numbers.exact().get(), session);
            } else {
                removeFrom(byRange, numbers, session);
            }
        });
    }

    private static <K> void removeFrom(Map<K, Route> routes, K key, EsmeSession session) {
        Route route = routes.get(key);
        if (route != null) {
            route.remove(session);
            if (route.isEmpty()) {
                routes.remove(key);
            }
        }
    }

    /** The session can take something again. */
    void roomOn(EsmeSession session, Optional<AddressRange> range, SmppServer server) {
        giveTurns(bySystemId.get(session.systemId()), server);
        range.ifPresent(numbers -> giveTurns(
                numbers.exact().isPresent() ? byNumber.get(numbers.exact().get()) : byRange.get(numbers), server));
    }

    private static void giveTurns(Route route, SmppServer server) {
        if (route != null) {
            route.giveTurns(server);
        }
    }

    private Optional<Route> routeOf(Recipient receiver) {
        return receiver instanceof Recipient.Esme esme
                ? Optional.ofNullable(bySystemId.get(esme.systemId()))
                : routeOf(((Recipient.Number) receiver).number());
    }

    private Optional<Route> routeOf(Msisdn number) {
        Route exact = byNumber.get(number);
        if (exact != null) {
            return Optional.of(exact);
        }
        if (byRange.isEmpty()) {
            return Optional.empty();
        }
        if (found.size() > MAX_REMEMBERED) {
            found.clear();
        }
        return found.computeIfAbsent(number, this::closestRange);
    }

    private Optional<Route> closestRange(Msisdn number) {
        AddressRange best = null;
        for (AddressRange range : byRange.keySet()) {
            if (range.contains(number) && (best == null || range.closeness() > best.closeness())) {
                best = range;
            }
        }
        return Optional.ofNullable(best).map(byRange::get);
    }

    @Override
    public boolean isReachable(Recipient receiver) {
        return routeOf(receiver).map(route -> route.admits(receiver)).orElse(false);
    }

    @Override
    public int window(Recipient receiver) {
        return Integer.MAX_VALUE;
    }

    @Override
    public void deliver(Envelope envelope, boolean moreWaiting, DeliveryReceipt receipt) {
        Optional<Route> route = routeOf(envelope.receiver());
        if (route.isEmpty()) {
            receipt.ended(DeliveryOutcome.ABSENT);
            return;
        }
        route.get().used();
        route.get().idlest().deliver(envelope, receipt);
    }
}
