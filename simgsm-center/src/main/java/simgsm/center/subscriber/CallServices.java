package simgsm.center.subscriber;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.StringJoiner;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.ss.ServiceStatus;
import simgsm.ss.SsCode;

/** A subscriber's settings of call forwarding (TS 23.082, 1.2) and call waiting (TS 23.083, 1). */
public final class CallServices {
    /** Service code, number, no reply time, active or not. */
    private static final Pattern PART = Pattern.compile("([0-9]+)=(?:(\\+?[0-9]+),)?(?:([0-9]+)s,)?(true|false)");

    private static final int USUAL_NO_REPLY_SECONDS = 20;

    private final Map<SsCode, Msisdn> forwardedTo = new EnumMap<>(SsCode.class);
    private final Set<SsCode> active = EnumSet.noneOf(SsCode.class);
    private Optional<Boolean> callWaiting = Optional.empty();
    private int noReplySeconds = USUAL_NO_REPLY_SECONDS;

    CallServices() {}

    /** Registers a number for one condition and activates the forwarding. */
    public void register(SsCode condition, Msisdn number) {
        forwardedTo.put(condition, number);
        active.add(condition);
    }

    /** Ringing time before forwarding. */
    public int noReplySeconds() {
        return noReplySeconds;
    }

    public void setNoReplySeconds(int seconds) {
        noReplySeconds = seconds;
    }

    public void erase(SsCode condition) {
        forwardedTo.remove(condition);
        active.remove(condition);
    }

    /** @return false if no number is registered */
    public boolean setForwarding(SsCode condition, boolean isActive) {
        if (!forwardedTo.containsKey(condition)) {
            return false;
        }
        if (isActive) {
            active.add(condition);
        } else {
            active.remove(condition);
        }
        return true;
    }

    /** The destination of calls on this condition as it was dialled; empty if they are not forwarded. */
    public Optional<Msisdn> forwarding(SsCode condition) {
        return active.contains(condition) ? Optional.of(forwardedTo.get(condition)) : Optional.empty();
    }

    public void setCallWaiting(boolean isActive) {
        callWaiting = Optional.of(isActive);
    }

    /**
     * True if a second call may wait.
     *
     * @param otherwise default without the subscriber's setting
     */
    public boolean hasCallWaiting(boolean otherwise) {
        return callWaiting.orElse(otherwise);
    }

    /** The status of a forwarding. */
    public ServiceStatus status(SsCode condition) {
        Optional<String> number =
                Optional.ofNullable(forwardedTo.get(condition)).map(Msisdn::toString);
        int flags = ServiceStatus.PROVISIONED
                | (number.isPresent() ? ServiceStatus.REGISTERED : 0)
                | (active.contains(condition) ? ServiceStatus.ACTIVE : 0);
        boolean isTimed = number.isPresent() && condition == SsCode.FORWARDING_ON_NO_REPLY;
        return new ServiceStatus(condition, flags, number, isTimed ? Optional.of(noReplySeconds) : Optional.empty());
    }

    /**
     * The stored form: {@code code=number,active} for each registered forwarding, {@code 61=number,25s,active} if the
     * no reply time is not 20 s, {@code 43=active} for call waiting set by the subscriber; separated by semicolons.
     */
    public String text() {
        StringJoiner parts = new StringJoiner(";");
        forwardedTo.forEach((condition, number) -> {
            boolean isTimed = condition == SsCode.FORWARDING_ON_NO_REPLY && noReplySeconds != USUAL_NO_REPLY_SECONDS;
            parts.add(condition.typed() + "=" + number + (isTimed ? "," + noReplySeconds + "s," : ",")
                    + active.contains(condition));
        });
        callWaiting.ifPresent(isActive -> parts.add(SsCode.CALL_WAITING.typed() + "=" + isActive));
        return parts.toString();
    }

    /**
     * Restores the result of {@link #text}.
     *
     * @throws IllegalArgumentException for any other text
     */
    public void restore(String text) {
        forwardedTo.clear();
        active.clear();
        callWaiting = Optional.empty();
        noReplySeconds = USUAL_NO_REPLY_SECONDS;
        for (String part : text.isEmpty() ? new String[0] : text.split(";")) {
            Matcher form = PART.matcher(part);
            Optional<SsCode> service = Stream.of(SsCode.values())
                    .filter(code -> form.matches() && code.typed().equals(form.group(1)))
                    .findFirst();
            if (service.isEmpty()) {
                throw new IllegalArgumentException("services of a subscriber: found " + part);
            }
            boolean isActive = Boolean.parseBoolean(form.group(4));
            if (form.group(2) == null) {
                setCallWaiting(isActive);
            } else {
                register(service.get(), Msisdn.parse(form.group(2)));
                setForwarding(service.get(), isActive);
                noReplySeconds = form.group(3) == null ? noReplySeconds : Integer.parseInt(form.group(3));
            }
        }
    }
}
