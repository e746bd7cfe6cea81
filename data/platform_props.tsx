<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.10" tiledversion="1.10.2" name="platform_props" tilewidth="64" tileheight="64" tilecount="2" columns="2" objectalignment="center">
 <image source="platform_tiles.png" width="128" height="64"/>
</tileset>
