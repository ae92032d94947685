package simgsm.center.smpp;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.center.smsc.ApplicationPort;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.Destination;
import simgsm.center.smsc.Envelope;

/** Delivers to applications: messages by the number that they serve, receipts by system id. */
public final class EsmeRoutes implements ApplicationPort {
    private static final int MAX_REMEMBERED = 100_000;

    private final Map<String, Route> bySystemId = new HashMap<>();
    private final Map<Msisdn, Route> byNumber = new HashMap<>();
    private final Map<AddressRange, Route> byRange = new LinkedHashMap<>();
    /** The result of {@link #closestRange} by number; cleared when a session is added or removed. */
    private final Map<Msisdn, Optional<Route>> found = new HashMap<>();

    EsmeRoutes() {}

    @Override
    public boolean servesExactly(Msisdn number) {
        return Optional.ofNullable(byNumber.get(number))
                .filter(route -> route.permits(number))
                .isPresent();
    }

    @Override
    public boolean serves(Msisdn number) {
        return routeOf(number).isPresent();
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

    /** Uses new space in a session's window. */
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

    /** Number of destinations that wait for their turn on the same route. */
    int blocked(Destination destination) {
        return routeOf(destination).map(Route::blocked).orElse(0);
    }

    private Optional<Route> routeOf(Destination destination) {
        return destination instanceof Destination.Esme esme
                ? Optional.ofNullable(bySystemId.get(esme.systemId()))
                : routeOf(((Destination.Number) destination).number());
    }

    private Optional<Route> routeOf(Msisdn number) {
        Route exact = byNumber.get(number);
        if (exact == null && byRange.isEmpty()) {
            return Optional.empty();
        }
        if (found.size() > MAX_REMEMBERED) {
            found.clear();
        }
        Optional<Route> route = exact == null ? found.computeIfAbsent(number, this::closestRange) : Optional.of(exact);
        return route.filter(each -> each.permits(number));
    }

    private Optional<Route> closestRange(Msisdn number) {
        AddressRange best = null;
        for (AddressRange range : byRange.keySet()) {
            if (range.contains(number)
                    && byRange.get(range).permits(number)
                    && (best == null || range.closeness() > best.closeness())) {
                best = range;
            }
        }
        return Optional.ofNullable(best).map(byRange::get);
    }

    @Override
    public boolean isReachable(Destination destination) {
        return routeOf(destination).map(route -> route.admits(destination)).orElse(false);
    }

    @Override
    public int window(Destination destination) {
        return Integer.MAX_VALUE;
    }

    @Override
    public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
        Optional<Route> route = routeOf(envelope.destination());
        route.ifPresent(Route::used);
        route.flatMap(Route::best)
                .ifPresentOrElse(
                        session -> session.deliver(envelope, ended), () -> ended.accept(DeliveryOutcome.WITHDRAWN));
    }

    @Override
    public void emptied(Destination destination) {
        routeOf(destination).ifPresent(route -> route.emptied(destination));
    }
}
