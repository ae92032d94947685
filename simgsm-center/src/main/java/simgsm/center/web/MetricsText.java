package simgsm.center.web;

/** Writes the text format of Prometheus, version 0.0.4. */
final class MetricsText {
    static final String TYPE = "text/plain; version=0.0.4; charset=utf-8";

    private final StringBuilder text = new StringBuilder();
    private String name = "";

    MetricsText gauge(String newName, String help) {
        return begin(newName, help, "gauge");
    }

    /** @param newName ends in {@code _total} */
    MetricsText counter(String newName, String help) {
        return begin(newName, help, "counter");
    }

    private MetricsText begin(String newName, String help, String type) {
        name = newName;
        text.append("# HELP ").append(name).append(' ').append(help).append('\n');
        text.append("# TYPE ").append(name).append(' ').append(type).append('\n');
        return this;
    }

    MetricsText value(long value) {
        text.append(name).append(' ').append(value).append('\n');
        return this;
    }

    /** @param labelValue without quotes, backslashes and ends of lines */
    MetricsText value(String label, String labelValue, long value) {
        text.append(name).append('{').append(label).append("=\"").append(labelValue);
        text.append("\"} ").append(value).append('\n');
        return this;
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
